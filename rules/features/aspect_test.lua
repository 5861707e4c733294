case("a keyboard is three times as long as wide", function()
  expect.value(3, flat { x = 0, y = 0, z = 0.7, length = 0.45, width = 0.15 })
end)

case("a square is 1, a hair is cut off at 100", function()
  expect.value(1, flat { x = 0, y = 0, z = 0.7, length = 0.5, width = 0.5 })
  expect.value(100, flat { x = 0, y = 0, z = 0.7, length = 5, width = 0.001 })
end)

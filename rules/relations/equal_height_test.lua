local desk = flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8 }

case("two desks side by side", function()
  expect.holds(desk, flat { x = 2, y = 0, z = 0.72, length = 1.6, width = 0.8 })
end)

case("a desk and a seat are not", function()
  expect.fails(desk, flat { x = 2, y = 0, z = 0.45, length = 0.4, width = 0.4 })
end)

case("halfway at 10 cm, in both directions", function()
  local higher = flat { x = 2, y = 0, z = 0.84, length = 1, width = 1 }
  expect.between(0.49, 0.51, desk, higher)
  expect.between(0.49, 0.51, higher, desk)
end)

case("a wall rises by its height, a table by nothing", function()
  expect.value(2.4, upright { x = 0, y = 0, z = 1.2, length = 3, width = 2.4 })
  expect.value(0, flat { x = 0, y = 0, z = 0.7, length = 1, width = 1 })
end)

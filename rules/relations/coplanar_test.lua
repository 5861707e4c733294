local wall = upright { x = 0, y = 2, z = 1.2, length = 2, width = 2.4, facing = -90 }

case("two parts of one wall", function()
  expect.holds(wall, upright { x = 3, y = 2.01, z = 1.2, length = 2, width = 2.4, facing = -90 })
end)

case("a board in front of the wall is half in its plane at 5.5 cm", function()
  expect.between(0.49, 0.51, wall, upright { x = 0, y = 1.945, z = 1.5, length = 1, width = 1, facing = -90 })
end)

case("parallel is not enough, nor is crossing", function()
  expect.fails(wall, upright { x = 0, y = 0, z = 1.2, length = 2, width = 2.4, facing = -90 })
  expect.fails(wall, upright { x = 0, y = 2, z = 1.2, length = 2, width = 2.4, facing = 0 })
end)

local screen = upright { x = 0, y = 1.2, z = 1.05, length = 0.5, width = 0.35, facing = -90 }

case("the foot of a screen is beneath it", function()
  expect.holds(flat { x = 0, y = 1.2, z = 0.76, length = 0.4, width = 0.2 }, screen)
end)

case("the keyboard before it is not", function()
  expect.fails(flat { x = 0, y = 0.9, z = 0.76, length = 0.45, width = 0.15 }, screen)
end)

case("nothing is beneath what lies lower", function()
  expect.fails(screen, flat { x = 0, y = 1.2, z = 0.76, length = 0.4, width = 0.2 })
end)

local desk = flat { x = 0, y = 1, z = 0.74, length = 1.6, width = 0.8 }
local screen = upright { x = 0, y = 1.2, z = 1.05, length = 0.5, width = 0.35, facing = -90 }

case("the desk is under the screen, not the screen under the desk", function()
  expect.holds(desk, screen)
  expect.fails(screen, desk)
end)

case("a lamp is under no floor", function()
  expect.fails(flat { x = 0, y = 0, z = 2, length = 0.3, width = 0.3 }, flat { x = 0, y = 0, z = 0, length = 5, width = 5 })
end)

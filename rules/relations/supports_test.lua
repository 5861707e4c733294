local desk = flat { x = 0, y = 1, z = 0.74, length = 1.6, width = 0.8 }

case("a desk supports the keyboard on it", function()
  expect.holds(desk, flat { x = 0, y = 0.8, z = 0.765, length = 0.45, width = 0.15, lean = 3 })
end)

case("a screen whose foot alone touches is supported to some degree", function()
  local screen = upright { x = 0, y = 1.2, z = 1.03, length = 0.5, width = 0.35, facing = -90 }
  expect.between(0.6, 0.85, desk, screen)
end)

case("a lamp above it is not, nor is the floor below", function()
  expect.fails(desk, flat { x = 0, y = 1, z = 1.6, length = 0.4, width = 0.4 })
  expect.fails(desk, flat { x = 0, y = 1, z = 0, length = 5, width = 5 })
end)

case("a wall carries nothing", function()
  local wall = upright { x = 0, y = 1, z = 0.5, length = 1, width = 1 }
  expect.fails(wall, flat { x = 0, y = 1, z = 1.01, length = 0.4, width = 0.4 })
end)

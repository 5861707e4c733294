local floor = flat { x = 0, y = 0, z = 0, length = 5, width = 4 }
local desk = flat { x = 0, y = 1, z = 0.74, length = 1.6, width = 0.8, lean = 1 }
local screen = upright { x = 0, y = 1.2, z = 1.05, length = 0.5, width = 0.35, facing = -90 }

case("a screen is above its desk, and the desk above the floor", function()
  expect.holds(screen, desk)
  expect.holds(desk, floor)
  expect.holds(screen, floor)
end)

case("never the other way round", function()
  expect.fails(desk, screen)
  expect.fails(floor, desk)
end)

case("a screen beside the desk is not above it", function()
  expect.fails(upright { x = 2, y = 1, z = 1.05, length = 0.5, width = 0.35, facing = -90 }, desk)
end)

case("a screen hides the strip of desk it stands on: near the outline is enough", function()
  local rest = flat { x = 0, y = 0.8, z = 0.74, length = 1.6, width = 0.5 }  -- ends 0.15 m before the screen
  expect.holds(screen, rest)
end)

case("a screen seen through the desk is not above it", function()
  expect.fails(upright { x = 0, y = 1, z = 0.6, length = 0.5, width = 0.5 }, desk)
end)

case("a noisy keyboard a centimetre into the desk still is", function()
  expect.holds(flat { x = 0, y = 0.8, z = 0.745, length = 0.45, width = 0.15, lean = 4 }, desk)
end)

case("half over the edge counts fully, a tenth hardly", function()
  local top = { y = 1, z = 1.2, length = 0.5, width = 0.35 }
  top.x = 0.8 + 0.25
  expect.holds(flat(top), desk)
  top.x = 0.8 + 0.25 + 0.25 - 0.05  -- 10 % within reach
  expect.fails(flat(top), desk)
end)

case("neither of two pieces of a noisy floor is above the other, unless by more than noise", function()
  local left = flat { x = -1, y = 0, z = 0, length = 2, width = 4, rmse = 0.01 }
  expect.fails(flat { x = 0, y = 0, z = 0.02, length = 2, width = 4, rmse = 0.012 }, left)
  expect.holds(flat { x = 0, y = 0, z = 0.06, length = 2, width = 4, rmse = 0.012 }, left)
end)

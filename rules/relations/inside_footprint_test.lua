local desk = flat { x = 0, y = 1, z = 0.74, length = 1.6, width = 0.8 }

case("a keyboard within the desk's edges, at any height", function()
  expect.holds(flat { x = 0, y = 1, z = 0.76, length = 0.45, width = 0.15 }, desk)
  expect.holds(flat { x = 0, y = 1, z = 0, length = 0.45, width = 0.15 }, desk)
end)

case("half beyond the edge is outside", function()
  expect.between(0, 0.25, flat { x = 0.8, y = 1, z = 0.76, length = 0.45, width = 0.15 }, desk)
end)

case("a screen counts by its length on the plan", function()
  expect.holds(upright { x = 0, y = 1.2, z = 1.05, length = 0.5, width = 0.35, facing = -90 }, desk)
end)

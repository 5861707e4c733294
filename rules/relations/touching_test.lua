local floor = flat { x = 0, y = 0, z = 0, length = 4, width = 3 }

case("a wall touches the floor it stands on, though the scan lost the edge", function()
  expect.holds(upright { x = 0, y = 1.5, z = 1.23, length = 4, width = 2.4, facing = -90 }, floor)
end)

case("a table top does not", function()
  expect.fails(flat { x = 0, y = 0, z = 0.74, length = 1, width = 1 }, floor)
end)

local floor = flat { x = 0, y = 0, z = 0, length = 4, width = 3 }

case("a wall is orthogonal to the floor, whichever way it faces", function()
  for _, facing in ipairs { 0, 37, 90, 200 } do
    expect.holds(upright { x = 0, y = 1.5, z = 1.2, length = 4, width = 2.4, facing = facing }, floor)
  end
end)

case("a screen may lean back a little", function()
  expect.holds(upright { x = 0, y = 0, z = 1, length = 0.5, width = 0.3, lean = 6 }, floor)
  expect.fails(upright { x = 0, y = 0, z = 1, length = 0.5, width = 0.3, lean = 20 }, floor)
end)

case("a table is not", function()
  expect.fails(flat { x = 0, y = 0, z = 0.7, length = 1, width = 1 }, floor)
end)

local wall = upright { x = 0, y = 1.5, z = 1.2, length = 4, width = 2.4, facing = -90 }  -- from x = -2 to 2

case("the next wall of the room does, though the scan lost the corner", function()
  expect.holds(upright { x = 2, y = 0, z = 1.2, length = 3, width = 2.4, facing = 180 }, wall)
  expect.holds(upright { x = 2, y = -0.08, z = 1.2, length = 3, width = 2.4, facing = 180 }, wall)
end)

case("so does the side of a pillar, whose edge points into the room", function()
  expect.holds(upright { x = 2, y = 1.8, z = 1.2, length = 0.6, width = 2.4, facing = 0 }, wall)
end)

case("a wall that goes on in the same plane does not", function()
  expect.fails(upright { x = 3, y = 1.5, z = 1.2, length = 2, width = 2.4, facing = -90 }, wall)
end)

case("nor does one across the room, or across the corner", function()
  expect.fails(upright { x = 2, y = -0.5, z = 1.2, length = 3, width = 2.4, facing = 180 }, wall)
  expect.fails(upright { x = 2, y = 1, z = 1.2, length = 1.4, width = 2.4, facing = -135 }, wall)
end)

case("what stands on top of the other shares no edge with it, what begins halfway up shares half", function()
  expect.fails(upright { x = 2, y = 0, z = 3.7, length = 3, width = 2.4, facing = 180 }, wall)
  expect.between(0.45, 0.55, upright { x = 2, y = 0, z = 3.0, length = 3, width = 2.4, facing = 180 }, wall)
end)

case("a floor is not upright", function()
  expect.fails(flat { x = 0, y = 0, z = 0, length = 4, width = 3 }, wall)
end)

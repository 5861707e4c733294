local wall = upright { x = 0, y = 1.5, z = 1.2, length = 4, width = 2.4, facing = 20 }
local function turned(by)
  return upright { x = 2, y = 0, z = 1.2, length = 3, width = 2.4, facing = 20 + by }
end

case("the walls of a room are, whichever way they face", function()
  for _, by in ipairs { 0, 90, 180, 270, 92 } do expect.holds(turned(by), wall) end
end)

case("a wall across a corner is not, one that is a little off is a little", function()
  expect.fails(turned(45), wall)
  expect.fails(turned(-80), wall)
  expect.between(0.3, 0.7, turned(96.5), wall)
end)

case("what lies is not asked", function()
  expect.fails(flat { x = 0, y = 0, z = 0.7, length = 1, width = 1 }, wall)
end)

local screen = upright { x = 0, y = 1, z = 1.05, length = 0.5, width = 0.35, facing = -90 }  -- faces -y

case("a keyboard lies in front of its screen", function()
  expect.holds(flat { x = 0.05, y = 0.7, z = 0.76, length = 0.45, width = 0.15 }, screen)
end)

case("behind it only to a half: the sensor may have seen the back", function()
  expect.between(0.45, 0.55, flat { x = 0.05, y = 1.3, z = 0.76, length = 0.45, width = 0.15 }, screen)
end)

case("the neighbour's keyboard is off to one side", function()
  expect.fails(flat { x = 1.2, y = 0.7, z = 0.76, length = 0.45, width = 0.15 }, screen)
end)

case("a table has no front", function()
  expect.fails(flat { x = 0, y = 0, z = 1, length = 0.2, width = 0.2 }, flat { x = 0, y = 0.2, z = 0.7, length = 1, width = 1 })
end)

local floor = flat { x = 0, y = 0, z = 0, length = 4, width = 3 }

case("a table top is parallel to the floor", function()
  expect.holds(flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8, lean = 2 }, floor)
end)

case("the side a normal points to does not matter", function()
  expect.holds(flat { x = 0, y = 0, z = 2.5, length = 4, width = 3, lean = 180 }, floor)
end)

case("a wall is not", function()
  expect.fails(upright { x = 0, y = 1.5, z = 1.2, length = 4, width = 2.4 }, floor)
end)

case("judgement fades between 5 and 12 degrees", function()
  expect.between(0.49, 0.51, flat { x = 0, y = 0, z = 1, length = 1, width = 1, lean = 8.5 }, floor)
end)

local desk = flat { x = 0, y = 0, z = 0.74, length = 1.6, width = 0.8 }

case("what lies on the desk is near it", function()
  expect.holds(flat { x = 0, y = 0, z = 0.76, length = 0.45, width = 0.15 }, desk)
end)

case("it is the gap that counts, not the centres", function()
  expect.holds(flat { x = 3.0, y = 0, z = 0.74, length = 4, width = 4 }, desk)
end)

case("two thirds of a metre away is half near", function()
  expect.between(0.49, 0.51, flat { x = 0.8 + 0.65 + 0.5, y = 0, z = 0.74, length = 1, width = 1 }, desk)
end)

case("across the room is not near", function()
  expect.fails(flat { x = 4, y = 0, z = 0.74, length = 1, width = 1 }, desk)
end)

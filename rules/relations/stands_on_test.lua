local desk = flat { x = 0, y = 1, z = 0.74, length = 1.6, width = 0.8 }
local keyboard = flat { x = 0, y = 0.8, z = 0.765, length = 0.45, width = 0.15, lean = 3 }

case("a keyboard stands on the desk, the desk on no keyboard", function()
  expect.holds(keyboard, desk)
  expect.fails(desk, keyboard)
end)

case("what hangs over the edge by more than half does not stand there", function()
  expect.fails(flat { x = 1.25, y = 1, z = 0.76, length = 0.5, width = 0.3 }, desk)
end)

case("a whole rectangle fills itself", function()
  expect.value(1, flat { x = 0, y = 0, z = 0.7, length = 1.6, width = 0.8 })
end)

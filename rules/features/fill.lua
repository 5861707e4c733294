-- Share of the smallest rectangle that the surface fills: near 1 for a whole screen or door, low for a wall with windows,
-- a floor full of furniture, the scattered bits of a plant.
return feature {
  name = "fill",
  unit = "1",
  summary = "area over that of the smallest rectangle",
  low = 0,
  high = 1,
  value = function(p)
    local rectangle = p.length * p.width
    if rectangle <= 0 then return nil end
    return math.min(p.area_m2 / rectangle, 1)
  end,
}

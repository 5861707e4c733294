-- How much height the surface spans: 2.5 m for a wall, 0.3 m for a screen, next to nothing for what lies flat.
return feature {
  name = "rise",
  unit = "m",
  summary = "from the lower to the upper edge",
  low = 0,
  high = 5,
  value = function(p) return math.min(math.max(p.z_max - p.z_min, 0), 5) end,
}

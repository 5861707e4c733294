-- Little room between the two, in any direction, measured between the outlines.
--
--      ____ a  <->  ____ b
return relation {
  api = 1,
  name = "near",
  summary = "the gap between a and b is small",
  symmetric = true,
  within = 1,
  full = 0.3,  -- metres: up to here fully
  none = 1.0,  -- from here on not at all
  degree = function(a, b, r) return falloff(geometry.gap(a, b, r.full, r.none), r.full, r.none) end,
}

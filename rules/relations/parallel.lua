-- Two surfaces that could be slid onto one another without turning: a table top and the floor, two facing walls.
--
--        ________ a                 ________ a
--                      parallel             \        not parallel
--        ________ b                          \ b
--
-- A scanned plane is rarely turned by more than 5 degrees against what it was; small ones by more, hence the slope.
return relation {
  api = 1,
  name = "parallel",
  summary = "a and b face the same way, or opposite ways",
  symmetric = true,
  within = 4,
  full = 5,   -- degrees: up to here fully
  none = 12,  -- degrees: from here on not at all
  degree = function(a, b, r) return falloff(geometry.angle(a, b), r.full, r.none) end,
}

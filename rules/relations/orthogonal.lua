-- Two surfaces at a right angle: a wall and the floor, a screen and its desk.
--
--        | a
--        |             orthogonal: 90 degrees, give or take
--        |______ b
return relation {
  api = 1,
  name = "orthogonal",
  summary = "a and b stand at a right angle",
  symmetric = true,
  within = 4,
  full = 6,   -- degrees off the right angle: up to here fully; a screen may lean a little
  none = 15,  -- from here on not at all
  degree = function(a, b, r) return falloff(90 - geometry.angle(a, b), r.full, r.none) end,
}

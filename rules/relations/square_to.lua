-- Two upright surfaces that run at a right angle or side by side, as the walls of most rooms do, and what is built in
-- between them. Seen from above:
--
--      a |            a _____
--        |
--        |______ b      _____ b
return relation {
  api = 1,
  name = "square_to",
  summary = "the upright a and b run parallel or at a right angle",
  symmetric = true,
  within = 4,
  upright = 75,  -- degrees from level: less steep surfaces are not asked
  full = 3,      -- degrees off: up to here fully
  none = 10,     -- from here on not at all
  applies = function(a, b, r) return a.tilt_deg > r.upright and b.tilt_deg > r.upright end,
  degree = function(a, b, r)
    local n, m = a.normal, b.normal
    local turn = math.deg(math.abs(math.atan(n.x * m.y - n.y * m.x, n.x * m.x + n.y * m.y))) % 90
    return falloff(math.min(turn, 90 - turn), r.full, r.none)
  end,
}

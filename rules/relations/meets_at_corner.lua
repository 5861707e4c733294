-- Two upright surfaces that meet along an upright edge: the walls of a room at its corners, the faces of a pillar. Whether the
-- edge points into the room or away from it makes no difference, nor does what is lost of it in the scan. Seen from above:
--
--      a |            a |
--        |______ b      |
--                  b ___|
return relation {
  api = 1,
  name = "meets_at_corner",
  summary = "the upright a and b meet at a right angle along an upright edge",
  symmetric = true,
  within = 0.3,
  upright = 75,   -- degrees from level: less steep surfaces are not asked
  square = 5,     -- degrees off a right angle: up to here fully
  oblique = 20,   -- from here on not at all
  beside = 0.5,   -- share of the lower one's height that both have in common: from here on fully
  full = 0.1,     -- metres of gap: up to here fully
  none = 0.3,     -- from here on not at all
  applies = function(a, b, r) return a.tilt_deg > r.upright and b.tilt_deg > r.upright end,
  degree = function(a, b, r)
    local common = math.min(a.z_max, b.z_max) - math.max(a.z_min, b.z_min)
    local lower = math.min(a.z_max - a.z_min, b.z_max - b.z_min)
    local beside = falloff(-common, -r.beside * lower, 0)
    local square = falloff(90 - geometry.angle(a, b), r.square, r.oblique)
    if beside * square == 0 then return 0 end
    return beside * square * falloff(geometry.gap(a, b, r.full, r.none), r.full, r.none)
  end,
}

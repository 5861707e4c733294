-- Parts of one and the same plane: a wall seen on both sides of a cupboard, a whiteboard flush with its wall.
--
--      ____ a     ______ b       on one line
return relation {
  api = 1,
  name = "coplanar",
  summary = "a and b lie in one plane",
  symmetric = true,
  within = 2,
  full_angle = 4,   -- degrees: up to here fully
  none_angle = 10,  -- from here on not at all
  full = 0.03,      -- metres off the other's plane: up to here fully
  none = 0.08,      -- from here on not at all
  applies = function(a, b, r) return geometry.angle(a, b) < r.none_angle end,
  degree = function(a, b, r)
    local off = math.max(geometry.plane_distance(a, b), geometry.plane_distance(b, a))
    return falloff(geometry.angle(a, b), r.full_angle, r.none_angle) * falloff(off, r.full, r.none)
  end,
}

-- Seen from above, a lies within the outline of b, at whatever height: a lamp over the room's floor, a rug, a keyboard
-- within its desk's edges (not merely touching them, as `above` allows).
--
--      seen from above:   +----------+
--                         |   [a]    | b
--                         +----------+
return relation {
  api = 1,
  name = "inside_footprint",
  summary = "seen from above, a lies within b",
  within_plan = 0.1,
  reach = 0.05,   -- metres beyond b's outline that still count as within
  enough = 0.95,  -- share of a's footprint: from here on fully
  some = 0.5,     -- up to here not at all
  degree = function(a, b, r) return falloff(geometry.footprint_overlap(a, b, r.reach, r.some, r.enough), r.enough, r.some) end,
}

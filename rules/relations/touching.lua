-- No room between the two: a wall and the floor it stands on, the two faces at a cabinet's edge. Scans lose points near
-- edges, where the beam hits both faces, so a few centimetres are no gap.
--
--      | a
--      |______ b
return relation {
  api = 1,
  name = "touching",
  summary = "a and b meet",
  symmetric = true,
  within = 0.15,
  full = 0.05,  -- metres: up to here fully
  none = 0.15,  -- from here on not at all
  degree = function(a, b, r) return falloff(geometry.gap(a, b, r.full, r.none), r.full, r.none) end,
}

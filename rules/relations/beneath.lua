-- a lies straight beneath b: the foot below its screen, the carpet below its table.
--
--        |b|
--        |_|
--       __a__
--
-- Unlike `under`, nothing beyond b's outline counts, so that what lies before a screen (its keyboard) is not beneath it.
return relation {
  api = 1,
  name = "beneath",
  summary = "a lies straight below b, inside its footprint",
  within = 0.5,
  within_plan = 0.1,
  reach = 0.04,   -- metres beyond a's outline, for noise and for the lean of a screen
  enough = 0.6,   -- share of b's footprint over a: from here on fully
  some = 0.2,     -- up to here not at all
  sink = 0.05,    -- metres by which b's lower edge may lie below a, for noise
  sunk = 0.15,
  applies = function(a, b, r)
    return (a.tilt_deg < 30 and a.height or a.z_max) - b.z_min < r.sunk and b.height > a.height
  end,
  degree = function(a, b, r)
    local top = a.tilt_deg < 30 and a.height or a.z_max
    return falloff(top - b.z_min, r.sink, r.sunk)
      * falloff(geometry.footprint_overlap(b, a, r.reach), r.enough, r.some)
  end,
}

-- a carries b: a is level, and b's lower edge rests on it. A desk supports a keyboard; the keyboard stands_on the desk.
--
--            |b|
--            |_|        b's lower edge within a few centimetres of a
--      ______________ a
--
-- Less patient than `under`, which lets b float at any height.
return relation {
  api = 1,
  name = "supports",
  summary = "b stands or lies on a",
  within = 0.3,
  within_plan = 0.2,
  level = 15,      -- degrees: a steeper a carries nothing
  reach = 0.15,    -- metres beyond a's outline that still count as on a
  enough = 0.6,    -- share of b's footprint: from here on fully
  some = 0.2,      -- up to here not at all
  rests = 0.06,    -- metres between b's lower edge and a: up to here fully (a keyboard's top, a screen's frame)
  floats = 0.25,   -- from here on not at all (a screen's foot may be all that touches)
  applies = function(a, b, r)
    return a.tilt_deg < r.level and b.z_min - a.height < r.floats and a.height - b.z_min < r.floats / 2
      and b.height > a.height
  end,
  degree = function(a, b, r)
    local lift = b.z_min - a.height
    if lift < 0 then lift = -2 * lift end  -- through the surface is worse than above it
    return falloff(lift, r.rests, r.floats)
      * falloff(geometry.footprint_overlap(b, a, r.reach, r.some, r.enough), r.enough, r.some)
  end,
}

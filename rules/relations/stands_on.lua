-- The other way round: a stands or lies on b where b supports a, to the same degree.
--
--            |a|
--            |_|
--      ______________ b
return relation {
  api = 1,
  name = "stands_on",
  summary = "a stands or lies on b",
  within = 0.3,
  within_plan = 0.2,
  level = 15,      -- as in supports.lua
  reach = 0.15,
  enough = 0.6,
  some = 0.2,
  rests = 0.06,
  floats = 0.25,
  applies = function(a, b, r)
    return b.tilt_deg < r.level and a.z_min - b.height < r.floats and b.height - a.z_min < r.floats / 2
      and a.height > b.height
  end,
  degree = function(a, b, r)
    local lift = a.z_min - b.height
    if lift < 0 then lift = -2 * lift end
    return falloff(lift, r.rests, r.floats) * falloff(geometry.footprint_overlap(a, b, r.reach), r.enough, r.some)
  end,
}

-- The other way round: a lies under b where b lies above a, to the same degree. The desk is under the screen.
--
--            |b|
--            |_|
--      ______________ a
return relation {
  api = 1,
  name = "under",
  summary = "a lies under b: lower, and b over its footprint",
  within_plan = 0.3,
  reach = 0.25,   -- as in above.lua
  enough = 0.5,
  some = 0.1,
  sink = 0.05,
  sunk = 0.15,
  same = 2,
  apart = 4,
  applies = function(a, b, r)
    return (a.tilt_deg < 30 and a.height or a.z_max) - b.z_min < r.sunk and b.height > a.height
  end,
  degree = function(a, b, r)
    local top = a.tilt_deg < 30 and a.height or a.z_max
    local lift = 1
    if a.tilt_deg < 30 and b.tilt_deg < 30 then
      local noise = math.max(a.rmse, b.rmse)
      lift = 1 - falloff(b.height - a.height, r.same * noise, r.apart * noise)
    end
    return lift * falloff(top - b.z_min, r.sink, r.sunk)
      * falloff(geometry.footprint_overlap(b, a, r.reach), r.enough, r.some)
  end,
}

-- a is higher than b and over its footprint, at any height: the ceiling over the floor, a screen over its desk.
--
--            |a|                      |a|
--            |_|                      |_|
--      ______________ b      _____          the second one only if the gap is within `reach`
--
-- The footprint is often torn: a screen hides the part of the desk it stands on. So a lies over b also where it lies
-- near b's outline, within `reach`; a share of `some` of a's footprint is too little, `enough` is plenty.
--
-- Of two level planes the higher one must be higher than noise: two pieces of one floor are at one height only as far as
-- the sensor can tell, so a difference of `same` deviations is none and one of `apart` deviations is plenty.
return relation {
  api = 1,
  name = "above",
  summary = "a lies over b: higher, and over its footprint",
  within_plan = 0.3,
  reach = 0.25,   -- metres beyond b's outline that still count as over b
  enough = 0.5,   -- share of a's footprint: from here on fully
  some = 0.1,     -- up to here not at all
  sink = 0.05,    -- metres by which a's lower edge may lie below b's surface, for noise
  sunk = 0.15,    -- from here on not at all
  same = 2,       -- deviations (rmse of the noisier plane) between two level planes that are no difference
  apart = 4,      -- and that are one
  applies = function(a, b, r)
    return (b.tilt_deg < 30 and b.height or b.z_max) - a.z_min < r.sunk and a.height > b.height
  end,
  degree = function(a, b, r)
    local top = b.tilt_deg < 30 and b.height or b.z_max
    local lift = 1
    if a.tilt_deg < 30 and b.tilt_deg < 30 then
      local noise = math.max(a.rmse, b.rmse)
      lift = 1 - falloff(a.height - b.height, r.same * noise, r.apart * noise)
    end
    return lift * falloff(top - a.z_min, r.sink, r.sunk)
      * falloff(geometry.footprint_overlap(a, b, r.reach, r.some, r.enough), r.enough, r.some)
  end,
}

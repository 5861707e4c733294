-- Centres at the same height above the floor: two desks side by side, a row of windows.
--
--      ____ a        ____ b       equal height
return relation {
  api = 1,
  name = "equal_height",
  summary = "the centres of a and b are equally high",
  symmetric = true,
  within = 4,
  full = 0.05,  -- metres of difference: up to here fully
  none = 0.15,  -- from here on not at all
  degree = function(a, b, r)
    local difference = a.height - b.height
    return falloff(difference < 0 and -difference or difference, r.full, r.none)
  end,
}

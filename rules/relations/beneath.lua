-- a lies straight beneath b: the foot below its screen, the carpet below its table.
--
--        |b|
--        |_|
--       __a__
--
-- As `under`, but nothing beyond b's outline counts, so that what lies before a screen (its keyboard) is not beneath it.
return relation {
  name = "beneath",
  extends = "under",
  summary = "a lies straight below b, inside its footprint",
  within = 0.5,
  within_plan = 0.1,
  reach = 0.04,   -- metres beyond a's outline, for noise and for the lean of a screen
  enough = 0.6,   -- share of b's footprint over a: from here on fully
  some = 0.2,     -- up to here not at all
}

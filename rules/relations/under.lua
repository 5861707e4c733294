-- The other way round: a lies under b where b lies above a, to the same degree. The desk is under the screen.
--
--            |b|
--            |_|
--      ______________ a
return relation {
  api = 1,
  name = "under",
  converse = "above",
  summary = "a lies under b: lower, and b over its footprint",
}

-- The other way round: a stands or lies on b where b supports a, to the same degree.
--
--            |a|
--            |_|
--      ______________ b
return relation {
  api = 1,
  name = "stands_on",
  converse = "supports",
  summary = "a stands or lies on b",
}

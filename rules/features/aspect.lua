-- Longer side over shorter side: about 3 for a keyboard, 1.6 to 1.8 for a screen, above 10 for skirting and cable ducts.
return feature {
  name = "aspect",
  unit = "1",
  summary = "length over width of the smallest rectangle",
  scale = "log",
  low = 1,
  high = 100,
  value = function(p)
    if p.width <= 0 then return nil end
    return math.min(math.max(p.length / p.width, 1), 100)
  end,
}

-- a lies where somebody sits who looks at b: a keyboard in front of a screen, a chair in front of a whiteboard. b stands
-- upright; a is on the side b's normal points to (towards the sensor), close, and not off to one side.
--
--      seen from above:    ======= b
--                             |
--                           [ a ]      up to `far` away, at most `aside` beyond b's ends
--
-- On the far side of b it holds only to the degree `behind`: the normal of a merged cloud may point either way.
return relation {
  api = 1,
  name = "in_front_of",
  summary = "a lies before the upright b, on the side it faces",
  within = 1,
  within_plan = 1,
  upright = 60,    -- degrees: a flatter b has no front
  close = 0.6,     -- metres from b's plane: up to here fully
  far = 1.0,       -- from here on not at all
  aside = 0.25,    -- metres beyond b's ends to the side: up to here not at all less
  beside = 0.5,    -- from here on not at all
  behind = 0.5,    -- degree on the far side, as a factor
  applies = function(_, b, r) return b.tilt_deg > r.upright end,
  degree = function(a, b, r)
    local n = b.normal
    local norm = math.sqrt(n.x * n.x + n.y * n.y)
    local dx, dy = a.x - b.x, a.y - b.y
    local before = (dx * n.x + dy * n.y) / norm
    local across = math.abs(dx * n.y - dy * n.x) / norm - b.length / 2
    local d = falloff(math.abs(before), r.close, r.far) * falloff(across, r.aside, r.beside)
    return before < 0 and d * r.behind or d
  end,
}

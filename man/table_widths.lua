-- Narrows tables so that they fit a terminal of 80 columns. Pandoc makes tables 70 columns wide, and
-- the gaps between their columns come on top; groff then warns of tables that are too wide.
function Table(made)
  for _, column in ipairs(made.colspecs) do
    if column[2] then column[2] = column[2] * 0.95 end
  end
  return made
end

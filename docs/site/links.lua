-- For pandoc: what names another page of the site leads there, and Sphinx says where it does not exist.

local function page(text, name)
  return pandoc.RawInline('rst', ':doc:`' .. text .. ' <' .. name .. '>`')
end

-- **tm-clean**(1)
function Inlines(inlines)
  local result = pandoc.List()
  local i = 1
  while i <= #inlines do
    local this, next = inlines[i], inlines[i + 1]
    local section = this.t == 'Strong' and next and next.t == 'Str' and next.text:match('^%((%d)%)')
    local title = section and pandoc.utils.stringify(this)
    if section and title:match('^tm') then
      result:insert(page(title .. '(' .. section .. ')', '/man/' .. title .. '.' .. section))
      local rest = next.text:sub(4)
      -- What follows a role is punctuation, or parted from it.
      if rest ~= '' then result:insert(pandoc.Str(rest)) end
      i = i + 2
    else
      result:insert(this)
      i = i + 1
    end
  end
  return result
end

-- [text](docs/design/cleaning.md), [text](docs/python.md#section), [text](python.md): a page of the site,
-- whose names are relative like those of files. Sphinx leads to the top of a page only.
function Link(link)
  local name = link.target:gsub('#.*$', ''):match('^(.+)%.md$')
  if not name or link.target:match('^%a+://') then return end
  name = name:gsub('^docs/', '')
  return page(pandoc.utils.stringify(link), name:lower())
end

-- The programs of a table
function Code(code)
  local name = code.text:match('^tm[%w-]*$')
  if name and PAGES[name] then return page(name, '/man/' .. name .. '.1') end
end

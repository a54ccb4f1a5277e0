-- A filter of pandoc: makes the body of a page of the report from the Markdown of a page. The program calls it
-- (src/report/convert.c) with these metadata:
--
--   links   lines TARGET<tab>ADDRESS<tab>CLASS<tab>VERDICT: for each target of a link of the page, its address in the report and
--           the verdict on the page there
--   figure  address of the drawn figure; empty: none
--
-- Raw HTML is dropped, and links that leave the report stay only if they are http, https or mailto, because pages come
-- from students. The line `checks` in the output marks where the table of the checks belongs.
--
-- Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

local addresses, classes, verdicts = {}, {}, {}
local signs = {pass = '✓', fail = '✗', none = '–'}
local figure = ''
local language = {scene = true, expect = true, ['contact-test'] = true}

local function html(text) return pandoc.RawBlock('html', text) end

local function escape(text) return (text:gsub('[&<>"]', {['&'] = '&amp;', ['<'] = '&lt;', ['>'] = '&gt;', ['"'] = '&quot;'})) end

-- The address in the report; nil: the target is not part of the report.
local function address_of(target)
  if target:match('^#') then return target end
  if target:match('^https?://') or target:match('^mailto:') then return target end
  local path, fragment = target:match('^([^#]*)(#?.*)$')
  if addresses[path] then return addresses[path] .. (addresses[path]:match('%.txt$') and '' or fragment), path end
end

local function link(element)
  local address, path = address_of(element.target)
  if not address then return pandoc.Span(element.content) end
  element.target, element.title = address, ''
  local verdict = path and verdicts[path] or ''
  if verdict == '' then return element end
  local class = classes[path]
  local sign = pandoc.Span(signs[class], pandoc.Attr('', {class}, {title = verdict, role = 'img', ['aria-label'] = verdict}))
  return {element, pandoc.Str('\u{a0}'), sign}
end

local function image(element)
  local address = address_of(element.src)
  if not address or address:match('^%a+:') then return pandoc.Emph(element.caption) end
  element.src = address
  return element
end

-- The title in a gnuplot script, which becomes the alternative text of the figure.
local function title_of(script)
  local title = script:match("set title '([^']*)'") or script:match('set title "([^"\\]*)"') or script:match("title '([^']+)'")
  return title or 'figure of this page'
end

-- The figure with its caption: the paragraph before the script.
local function add_figure(blocks, script)
  local caption = blocks[#blocks]
  if caption and caption.t == 'Para' then blocks:remove(#blocks) else caption = nil end
  blocks:insert(html('<figure>'))
  if figure ~= '' then
    blocks:insert(html('<img src="' .. escape(figure) .. '" alt="' .. escape(title_of(script)) .. '">'))
  else
    blocks:insert(html('<p class="none">The figure was not drawn.</p>'))
  end
  if caption then
    blocks:insert(html('<figcaption>'))
    blocks:insert(caption)
    blocks:insert(html('</figcaption>'))
  end
  blocks:insert(html('</figure>'))
end

-- A long formula scrolls by itself on a narrow screen.
local function math(element)
  if element.mathtype == 'DisplayMath' then return pandoc.Span(element, pandoc.Attr('', {'formula'})) end
  if #element.text > 40 then return pandoc.Span(element, pandoc.Attr('', {'long'})) end
end

function Meta(meta)
  for line in pandoc.utils.stringify(meta.links or ''):gmatch('[^\n]+') do
    local target, address, class, verdict = line:match('^([^\t]*)\t([^\t]*)\t([^\t]*)\t(.*)$')
    addresses[target], classes[target], verdicts[target] = address, class, verdict
  end
  figure = pandoc.utils.stringify(meta.figure or '')
end

function Pandoc(document)
  local blocks, last = pandoc.List(), 0
  for k, block in ipairs(document.blocks) do
    if block.t == 'CodeBlock' and block.classes[1] == 'expect' then last = k end
  end
  local drawn = false
  for k, block in ipairs(document.blocks) do
    local kind = block.t == 'CodeBlock' and block.classes[1]
    if kind == 'gnuplot' then
      if not drawn then add_figure(blocks, block.text) end
      drawn = true
      blocks:extend({html('<details><summary>gnuplot script</summary>'), block, html('</details>')})
    elseif language[kind] then
      block.attributes['aria-label'] = kind
      blocks:insert(block)
    else
      blocks:insert(block)
    end
    if k == last then blocks:insert(html('<!--nineball: checks-->')) end
  end
  document.blocks = blocks
  return document
end

local function drop() return {} end

return {
  {RawInline = drop, RawBlock = drop},
  {Meta = Meta},
  {Link = link, Image = image, Math = math},
  {Pandoc = Pandoc},
}

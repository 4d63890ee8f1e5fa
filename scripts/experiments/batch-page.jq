# The page of a batch: rows as `batch collect` writes them, $title, $style, and $files: the names
# of existing pictures and pages.
def unique_in_order: reduce .[] as $one ([]; if index([$one]) then . else . + [$one] end);
def counted($noun): "\(.) \($noun)\(if . == 1 then "" else "s" end)";

# The outcome of a run, in one cell.
def cell:
  "pictures/\(.shape),\(.run).png" as $picture
  | if .exit_code == null then "<td class=\"open\">\(.message | @html)</td>"
    elif .exit_code != 0 then
      "<td class=\"failed\"><strong>failed</strong>, exit code \(.exit_code) of the \(.failed_step | @html):<br>\(.message | @html)</td>"
    else
      "<td>"
      + (if $files | index([$picture]) then
          "<img src=\"\($picture | @html)\" width=\"320\" height=\"240\" alt=\"\(.run | @html) of \(.shape | @html)\"><br>"
        else "" end)
      + ([(if .["output.faces"] then "\(.["output.faces"]) faces" else empty end),
          (if .genus then "genus \(.genus)" else empty end),
          (if .components then (.components | counted("component")) else empty end),
          (if .iterations then (.iterations | counted("iteration")) else empty end),
          (if .seconds then "\(.seconds * 100 | round / 100) s" else empty end)] | join(", "))
      + "</td>"
    end;

def head_of_shape:
  . as $shape
  | [$files[] | select(. == "3d/\($shape).html" or startswith("3d/\($shape),"))] as $pages
  | "<th scope=\"row\">\($shape | @html)"
    + ($pages | to_entries | map("<br><a href=\"\(.value | @html)\">in 3D\(if .key > 0 then ", \(.key + 1)" else "" end)</a>") | join(""))
    + "</th>";

def grid:
  . as $rows
  | (map(.run) | unique_in_order) as $runs
  | "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Results\"><table class=\"grid\"><thead><tr><td></td>\($runs | map("<th scope=\"col\">\(@html)</th>") | join(""))</tr></thead>",
    "<tbody>",
    (map(.shape) | unique_in_order | .[] as $shape
      | "<tr>\($shape | head_of_shape)"
        + ([$runs[] as $run | first($rows[] | select(.shape == $shape and .run == $run)) | cell] | join(""))
        + "</tr>"),
    "</tbody></table></div>";

def failures:
  map(select((.exit_code // 0) != 0))
  | if length == 0 then empty else
      "<h2>Failures</h2>", "<ul>",
      (.[] | "<li>\(.shape | @html), \(.run | @html): exit code \(.exit_code) of the \(.failed_step | @html): <code>\(.message | @html)</code></li>"),
      "</ul>"
    end;

def numbers:
  (map(keys_unsorted) | add | unique_in_order) as $keys
  | "<h2>Numbers</h2>",
    "<p>As in <a href=\"table.csv\">table.csv</a>.</p>",
    "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Numbers\"><table><thead><tr>\($keys | map("<th scope=\"col\">\(gsub("_"; " ") | @html)</th>") | join(""))</tr></thead>",
    "<tbody>",
    (.[] | . as $row | "<tr>\($keys | map("<td>\($row[.] // "" | if type == "number" then . else tostring end | tostring | @html)</td>") | join(""))</tr>"),
    "</tbody></table></div>";

def kinds:
  [(map(select(.exit_code == 0)) | length | "\(.) done"),
   (map(select((.exit_code // 0) != 0)) | length | "\(.) failed"),
   (map(select(.exit_code == null)) | length | "\(.) not ended")] | join(", ");

"<!doctype html>",
"<html lang=\"en\">",
"<head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">",
"<title>\($title | @html)</title><style>\($style)</style></head>",
"<body><main>",
"<h1>\($title | @html)</h1>",
"<p>\(length | counted("run")): \(kinds). Each row is a shape, each column a set of parameters.</p>",
grid, failures, numbers,
"</main></body></html>"

# The page of scripts/bench/thingi: rows as its table.csv has them; $folder, the name of the folder of the
# meshes, and $style.
def rounded: if . == null then "" else . * 1000 | round / 1000 end;
def row($cells; $kind): "<tr>" + ($cells | map("<\($kind)>\(. // "" | tostring | @html)</\($kind)>") | join("")) + "</tr>";
def table($head): "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"\($head[0])\"><table>", row($head; "th"), (.[] | row(.; "td")), "</table></div>";

def outcomes:
  group_by(.outcome) | map([.[0].outcome, length, (map(.faces // 0) | add), (map(.seconds // 0) | add | rounded)])
  | table(["outcome", "meshes", "faces", "seconds of tm-clean"]);

def others:
  map(select(.outcome != "certified")) | sort_by(.outcome, .mesh)
  | if length == 0 then empty else
      "<h2>Meshes without a certified result</h2>",
      (map([.outcome, .mesh, .faces, .step, .exit_code, .message])
        | table(["outcome", "mesh", "faces", "step", "exit code", "message"]))
    end;

def slowest:
  "<h2>Slowest</h2>",
  (map(select(.seconds)) | sort_by(-.seconds, .mesh) | .[:20]
    | map([.mesh, .faces, .pairs, (.seconds | rounded), (.peak_memory_bytes / 1e6 | round), .outcome])
    | table(["mesh", "faces", "intersecting pairs", "seconds", "MB", "outcome"]));

"<!doctype html>",
"<html lang=\"en\">",
"<head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">",
"<title>\($folder | @html), cleaned and certified</title><style>\($style)</style></head>",
"<body><main>",
"<h1>\($folder | @html), cleaned and certified</h1>",
"<p>\(map(select(.outcome == "certified")) | length) of \(length) meshes have a certified result. All rows: <a href=\"table.csv\">table.csv</a>.</p>",
outcomes, others, slowest,
"</main></body></html>"

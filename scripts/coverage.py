"""What gcov counted, by folder: lines of src/ and cli/ that ran, and those that could have. It fails below a floor."""

import json
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ran = defaultdict(dict)  # of each file, whether each of its lines ran
for document in open(sys.argv[1], encoding="utf-8"):
    report = json.loads(document)
    for file in report["files"]:
        path = Path(report["current_working_directory"], file["file"]).resolve()
        if path.is_relative_to(ROOT) and path.relative_to(ROOT).parts[0] in ("src", "cli"):
            lines = ran[path.relative_to(ROOT)]
            for line in file["lines"]:
                number = line["line_number"]
                lines[number] = lines.get(number, False) or line["count"] > 0

folders = defaultdict(lambda: [0, 0])
for path, lines in ran.items():
    parts = path.parts
    for folder in ("/".join(parts[:-1]), f"{parts[0]}, all"):
        folders[folder][0] += sum(lines.values())
        folders[folder][1] += len(lines)
print(f"{'folder':32} {'lines ran':>10} {'of':>6} {'share':>8}")
for folder, (hit, of) in sorted(folders.items()):
    print(f"{folder:32} {hit:10} {of:6} {hit / of:8.2%}")
for part, floor in (("src", 0.982), ("cli", 0.965)):
    hit, of = folders[f"{part}, all"]
    if hit < floor * of:
        sys.exit(f"coverage: {part}: got {hit / of:.2%}, allowed {floor:.1%} or more")

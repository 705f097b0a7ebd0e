"""The parts of scripts/report.py: tables are read (tables), counted (found), drawn (figures, drawing, stability), marked up
(markup), and put into sections (ledger, sections) and a page (page). scripts/check_report.py drives a browser (browser) over
the result."""

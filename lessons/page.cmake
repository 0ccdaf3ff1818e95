# The sources of byhand_page, which WebAssembly has too.
set(page chart_words claim_words equations excerpt grading items lesson page parameter recording typed_quantity words)
list(TRANSFORM page PREPEND tutor/)
list(APPEND page site/alternative site/code_html site/colours site/drawn site/markup site/mathml site/step_html)
list(TRANSFORM page APPEND .cpp)

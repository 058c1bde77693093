" SPDX-License-Identifier: BSD-3-Clause
if exists('b:current_syntax')
  finish
endif

syntax case ignore
syntax match icarusHost /{\s*\zs[^ \t(){}";?:]\+/
syntax match icarusSkill /^(\s*\zs[^ \t(){}";?:]\+/
syntax match icarusBuiltin /{\s*\zs\(!=\|<=\|>=\|=\|<\|>\|+\|-\|\*\|\/\|min\|max\|abs\|round\|list\|member\|store\|forget\|update\)\ze\_[ \t(){}";]/
syntax match icarusForm /(\s*\zs\(constant\|facts\|top\|never\|functions\|cycle\|answer\|expect\|repeat\|idle\)\ze\_[ \t(){}";]/
syntax match icarusClause /(\s*\zs\(bind\|\*not\*\|\*nota\*\)\ze\_[ \t(){}";]/
syntax match icarusSlot /:\(objective\|requires\|means\|sequence\|action\|sensor\|value\)\ze\_[ \t(){}";]/
syntax match icarusVariable /?[^ \t(){}";]*/
syntax match icarusConstant /\*[^ \t(){}";*]\+\*/
syntax match icarusNumber /\(^\|[ \t({]\)\@<=[+-]\=\d\+\(\.\d\+\)\=\(e[+-]\=\d\+\)\=\ze\([ \t(){}";]\|$\)/
syntax match icarusEscape /\\./ contained
syntax region icarusString start=/"/ end=/"/ oneline contains=icarusEscape
syntax match icarusComment /;.*$/

highlight default link icarusHost Function
highlight default link icarusSkill Type
highlight default link icarusBuiltin Operator
highlight default link icarusForm PreProc
highlight default link icarusClause Conditional
highlight default link icarusSlot Keyword
highlight default link icarusVariable Identifier
highlight default link icarusConstant Constant
highlight default link icarusNumber Number
highlight default link icarusEscape SpecialChar
highlight default link icarusString String
highlight default link icarusComment Comment

let b:current_syntax = 'icarus'

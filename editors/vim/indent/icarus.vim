" SPDX-License-Identifier: BSD-3-Clause
if exists('b:did_indent')
  finish
endif
let b:did_indent = 1

setlocal lisp autoindent expandtab
setlocal lispwords=constant,facts,top,never,cycle
let b:undo_indent = 'setlocal lisp< autoindent< expandtab< lispwords<'

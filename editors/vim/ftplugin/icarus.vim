" SPDX-License-Identifier: BSD-3-Clause
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal comments=:; commentstring=;\ %s
setlocal iskeyword=33,35-39,42-58,60-122,124,126,192-255
if executable('latchwork')
  setlocal makeprg=latchwork\ icarus\ check\ %
  setlocal errorformat=%f:%l:%c:\ %trror[I%n]:\ %m,%f:%l:%c:\ %tarning[I%n]:\ %m,%-G%.%#
endif

let b:undo_ftplugin = 'setlocal comments< commentstring< iskeyword< makeprg< errorformat<'

" SPDX-License-Identifier: BSD-3-Clause
autocmd BufNewFile,BufRead *.icarus,*.world setfiletype icarus

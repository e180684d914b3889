/* The player's script, as it stands in docs/players/dist, between two labels. */
    .section .rodata
    .global carom_player_begin
    .global carom_player_end
    .balign 16
carom_player_begin:
    .incbin CAROM_PLAYER_FILE
carom_player_end:
    .byte 0
    .section .note.GNU-stack,"",%progbits

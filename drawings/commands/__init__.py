"""The commands, one file each; a command imports only what it needs."""

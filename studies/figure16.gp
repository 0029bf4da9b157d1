# picture of figure16

# picture of figure15
